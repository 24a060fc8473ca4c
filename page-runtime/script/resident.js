// All words of the volume are on the device.
const makeVolume = () => ({ isStreamed: false, ...device.hold(words) });
