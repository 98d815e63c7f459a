namespace UnityEngine;

enum WorldKind
{
    /// <summary>Scripts sleep, but those that say that they run in edit mode.</summary>
    Editing,

    Playing,

    /// <summary>Holds what is in files: nothing of it is in a scene, and nothing may destroy it by mistake.</summary>
    Assets,
}
