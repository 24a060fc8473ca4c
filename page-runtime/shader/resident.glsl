// All words of the volume are here.
bool lacks_page() { return false; }
