namespace UnityEngine;

/// <summary>The root objects of a scene, in order.</summary>
sealed class SceneContent(int handle)
{
    readonly List<GameObject> _roots = new();

    internal int Handle { get; } = handle;
    internal bool IsLoaded { get; set; } = true;
    internal IReadOnlyList<GameObject> Roots => _roots;

    /// <summary>Adds hierarchies that were created outside of scenes, and then activates them all at once.</summary>
    internal void Adopt(IReadOnlyList<GameObject> roots)
    {
        foreach (var root in roots)
        {
            _roots.Add(root);
            root.MoveTo(this);
        }

        Lifecycle.Activate(roots);
    }

    internal void Add(GameObject root) => _roots.Add(root);

    internal void Remove(GameObject root) => _roots.Remove(root);

    internal int IndexOf(GameObject root) => _roots.IndexOf(root);

    internal void Collect(List<GameObject> into)
    {
        foreach (var root in _roots) Hierarchy.Collect(root, into);
    }
}
