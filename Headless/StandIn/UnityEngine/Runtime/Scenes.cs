namespace UnityEngine;

/// <summary>The loaded scenes of a world.</summary>
sealed class Scenes
{
    readonly List<SceneContent> _loaded = new();
    int _lastHandle;

    internal Scenes() => Active = Add();

    /// <summary>The active scene, to which new objects are added.</summary>
    internal SceneContent Active { get; set; }

    internal IReadOnlyList<SceneContent> Loaded => _loaded;

    /// <summary>Index of the open scene among the ticked scenes in the Build Settings, and their number.</summary>
    internal (int Index, int Count) BuildList { get; set; }

    internal SceneContent Add()
    {
        var made = new SceneContent(--_lastHandle);
        _loaded.Add(made);
        return made;
    }

    internal void Forget(SceneContent scene)
    {
        scene.IsLoaded = false;
        _loaded.Remove(scene);
    }

    /// <summary>Returns all objects of all scenes, parents before their children.</summary>
    internal IEnumerable<GameObject> GameObjects()
    {
        var found = new List<GameObject>();
        foreach (var scene in _loaded) scene.Collect(found);
        return found;
    }

    internal IEnumerable<GameObject> Roots()
    {
        var found = new List<GameObject>();
        foreach (var scene in _loaded) found.AddRange(scene.Roots);
        return found;
    }
}
