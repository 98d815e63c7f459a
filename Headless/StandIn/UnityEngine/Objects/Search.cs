namespace UnityEngine;

/// <summary>Finds objects in the loaded scenes, in the order of the hierarchy.</summary>
static class Search
{
    internal static T First<T>(bool includeInactive) where T : Object
    {
        var found = All<T>(includeInactive);
        return found.Count > 0 ? found[0] : null;
    }

    internal static List<T> All<T>(bool includeInactive) where T : Object
    {
        var found = new List<T>();
        foreach (var gameObject in World.Current.Scenes.GameObjects())
        {
            if (!includeInactive && !gameObject.activeInHierarchy) continue;

            if (gameObject is T wanted) found.Add(wanted);
            AddComponents(gameObject, found);
        }

        return found;
    }

    static void AddComponents<T>(GameObject gameObject, List<T> found) where T : Object
    {
        foreach (var component in gameObject.Components)
        {
            if (component is T wanted) found.Add(wanted);
        }
    }
}
