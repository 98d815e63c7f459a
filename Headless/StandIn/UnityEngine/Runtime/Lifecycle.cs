namespace UnityEngine;

/// <summary>Activates and deactivates objects.</summary>
static class Lifecycle
{
    internal static void Activate(GameObject root) => Activate(new[] { root });

    /// <summary>
    /// Activates the objects of hierarchies whose active flag is set. Calls Awake and OnEnable script by script, in the execution order.
    /// </summary>
    internal static void Activate(IReadOnlyList<GameObject> roots)
    {
        var waking = new List<GameObject>();
        foreach (var root in roots)
        {
            if (ShouldBeActive(root)) CollectActive(root, waking);
        }

        foreach (var gameObject in waking) gameObject.SetActiveInHierarchy(true);
        // OrderBy is stable, so components with the same execution order stay in the order of the hierarchy.
        foreach (var component in waking.SelectMany(g => g.Components).OrderBy(Order).ToList())
        {
            // Another script may have deactivated or destroyed this component in its Awake.
            if (!component.Destroyed && component.Owner.activeInHierarchy) component.Activated();
        }
    }

    /// <summary>Activates or deactivates an object and its descendants after its active flag or its parent has changed.</summary>
    internal static void Refresh(GameObject changed)
    {
        if (ShouldBeActive(changed) == changed.activeInHierarchy) return;

        if (changed.activeInHierarchy) Deactivate(changed);
        else Activate(changed);
    }

    /// <summary>Deactivates an object and its descendants, children before their parents.</summary>
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

    /// <summary>Calls OnTransformParentChanged of the scripts on an object and its descendants, including disabled scripts.</summary>
    internal static void ReportNewParent(GameObject moved)
    {
        var objects = new List<GameObject>();
        Hierarchy.Collect(moved, objects);
        foreach (var script in objects.SelectMany(g => g.Components).OfType<MonoBehaviour>().ToList())
        {
            if (!script.Destroyed && script.Awoken) script.Script.Call(Message.OnTransformParentChanged, script);
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

    // Unity's own components come before all scripts.
    static int Order(Component component) => component is MonoBehaviour script ? script.Script.Order : int.MinValue;
}
