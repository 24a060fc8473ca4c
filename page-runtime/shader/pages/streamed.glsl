// Of the volume some pages are here.
bool lacks_page() { return voxc_scene_lacks_page; }
