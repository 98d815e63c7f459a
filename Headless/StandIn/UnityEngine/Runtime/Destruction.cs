namespace UnityEngine;

/// <summary>Destroys objects: immediately, or at two points of a frame, before the rendering and at the end of the frame.</summary>
sealed class Destruction(World world)
{
    readonly List<Object> _waiting = new();
    readonly HashSet<Object> _ending = new();

    internal void Later(Object what)
    {
        if (!MayEnd(what, false)) return;

        if (!world.IsPlaying)
        {
            Debug.LogError(
                "Destroy may not be called from edit mode! Use DestroyImmediate instead.\n" +
                "Destroying an object in edit mode destroys it permanently.", what);
        }
        else _waiting.Add(what);
    }

    internal void Now(Object what, bool alsoAssets)
    {
        if (MayEnd(what, alsoAssets)) End(what);
    }

    /// <summary>Destroys the objects that wait for it.</summary>
    internal void Flush()
    {
        // Objects that an OnDestroy adds to the list are destroyed in the same pass.
        for (var i = 0; i < _waiting.Count; i++)
        {
            if (Object.Alive(_waiting[i])) End(_waiting[i]);
        }

        _waiting.Clear();
    }

    internal void End(Object what)
    {
        if (!_ending.Add(what)) return;

        if (what is GameObject gameObject) End(gameObject);
        else if (what is Component component) End(component);
        else
        {
            (what as ScriptableObject)?.Sleep();
            what.MarkDestroyed();
        }

        _ending.Remove(what);
    }

    static void End(GameObject top)
    {
        Lifecycle.Deactivate(top);
        var ending = new List<GameObject>();
        Hierarchy.Collect(top, ending);
        foreach (var gameObject in ending)
        {
            foreach (var component in new List<Component>(gameObject.Components)) component.Destroying();
        }

        top.transform.Leave();
        foreach (var gameObject in ending)
        {
            foreach (var component in gameObject.Components) component.MarkDestroyed();
            gameObject.MarkDestroyed();
        }
    }

    static void End(Component component)
    {
        (component as Behaviour)?.SetRunning(false);
        component.Destroying();
        component.Owner.Remove(component);
        component.MarkDestroyed();
    }

    bool MayEnd(Object what, bool alsoAssets)
    {
        if (what is Transform)
        {
            Debug.LogError(
                $"Can't destroy Transform component of '{what.name}'. If you want to destroy the game object, please call 'Destroy' on the game " +
                "object instead. Destroying the transform component is not allowed.", what);
            return false;
        }

        if (what.IsAsset && !alsoAssets)
        {
            Debug.LogError("Destroying assets is not permitted to avoid data loss.", what);
            return false;
        }

        return !NeededByOther(what);
    }

    static bool NeededByOther(Object what)
    {
        if (what is not Component component) return false;

        foreach (var other in component.Owner.Components)
        {
            if (ReferenceEquals(other, component)) continue;

            foreach (var type in Requirements.Of(other.GetType()).Types)
            {
                if (!type.IsInstanceOfType(component) || component.GetComponents(type).Length > 1) continue;

                Debug.LogError($"Can't remove {component.GetType().Name} because {other.GetType().Name} (Script) depends on it", component);
                return true;
            }
        }

        return false;
    }
}
