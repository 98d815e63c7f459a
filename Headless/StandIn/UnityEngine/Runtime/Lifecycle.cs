using System.Collections.Generic;
using System.Linq;

namespace UnityEngine;

/// <summary>Activates and deactivates objects.</summary>
static class Lifecycle
{
    internal static void Activate(GameObject root) => Activate(new[] { root });

    /// <summary>Wakes and enables all active objects of the hierarchies, script by script in the execution order.</summary>
    internal static void Activate(IReadOnlyList<GameObject> roots)
    {
        var waking = new List<GameObject>();
        foreach (var root in roots)
        {
            if (ShouldBeActive(root)) CollectActive(root, waking);
        }

        foreach (var gameObject in waking) gameObject.SetActiveInHierarchy(true);
        // OrderBy keeps the hierarchy's order among equals.
        foreach (var component in waking.SelectMany(g => g.Components).OrderBy(Order).ToList())
        {
            // A script that woke earlier may have deactivated or destroyed it.
            if (!component.Destroyed && component.Owner.activeInHierarchy) component.Activated();
        }
    }

    /// <summary>Updates an object and its descendants after its flag or its parent has changed.</summary>
    internal static void Refresh(GameObject changed)
    {
        if (ShouldBeActive(changed) == changed.activeInHierarchy) return;

        if (changed.activeInHierarchy) Deactivate(changed);
        else Activate(changed);
    }

    /// <summary>Deactivates a hierarchy, children before their parents.</summary>
    internal static void Deactivate(GameObject root)
    {
        var stopping = new List<GameObject>();
        Hierarchy.Collect(root, stopping);
        stopping.Reverse();
        stopping.RemoveAll(g => !g.activeInHierarchy);
        foreach (var gameObject in stopping) gameObject.SetActiveInHierarchy(false);
        foreach (var component in stopping.SelectMany(g => g.Components).ToList())
        {
            if (!component.Destroyed && !component.Owner.activeInHierarchy) component.Deactivated();
        }
    }

    static bool ShouldBeActive(GameObject g)
    {
        var parent = g.transform.parent;
        return g.Content != null && g.activeSelf && (parent is null || parent.gameObject.activeInHierarchy);
    }

    static void CollectActive(GameObject top, List<GameObject> into)
    {
        if (!top.activeSelf) return;

        into.Add(top);
        for (var i = 0; i < top.transform.childCount; i++) CollectActive(top.transform.GetChild(i).gameObject, into);
    }

    // The engine's own components come before all scripts.
    static int Order(Component component) => component is MonoBehaviour script ? script.Script.Order : int.MinValue;
}
