using System.Collections.Generic;

namespace UnityEngine;

/// <summary>The loaded scenes of a world.</summary>
sealed class Scenes
{
    readonly List<SceneContent> _loaded = new();
    int _lastHandle;
    SceneContent _kept;

    internal Scenes() => Active = Add("", "");

    /// <summary>The active scene, to which new objects are added.</summary>
    internal SceneContent Active { get; set; }

    internal IReadOnlyList<SceneContent> Loaded => _loaded;

    internal SceneContent Add(string name, string path)
    {
        var made = new SceneContent(--_lastHandle, name, path);
        _loaded.Add(made);
        return made;
    }

    internal void Forget(SceneContent scene)
    {
        scene.IsLoaded = false;
        _loaded.Remove(scene);
    }

    /// <summary>Moves a root object to a scene that is never unloaded.</summary>
    internal void Keep(GameObject root)
    {
        _kept ??= new SceneContent(--_lastHandle, "DontDestroyOnLoad", "");
        if (root.transform.parent is null) _kept.Take(root);
        else Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.", root);
    }

    /// <summary>Returns all objects of all scenes, parents before their children.</summary>
    internal IEnumerable<GameObject> GameObjects()
    {
        var found = new List<GameObject>();
        foreach (var scene in _loaded) scene.Collect(found);
        _kept?.Collect(found);
        return found;
    }

    internal IEnumerable<GameObject> Roots()
    {
        var found = new List<GameObject>();
        foreach (var scene in _loaded) found.AddRange(scene.Roots);
        if (_kept != null) found.AddRange(_kept.Roots);
        return found;
    }
}
