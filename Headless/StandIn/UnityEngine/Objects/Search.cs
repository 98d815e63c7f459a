using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Finds objects in the loaded scenes, in the order of the hierarchy.</summary>
static class Search
{
    internal static Object First(Type type, bool includeInactive)
    {
        var found = All<Object>(type, includeInactive);
        return found.Count > 0 ? found[0] : null;
    }

    internal static List<T> All<T>(Type type, bool includeInactive) where T : Object
    {
        var found = new List<T>();
        foreach (var gameObject in World.Current.Scenes.GameObjects())
        {
            if (!includeInactive && !gameObject.activeInHierarchy) continue;

            if (type == typeof(GameObject)) found.Add((T)(Object)gameObject);
            else AddComponents(gameObject, type, found);
        }

        return found;
    }

    static void AddComponents<T>(GameObject gameObject, Type type, List<T> found) where T : Object
    {
        foreach (var component in gameObject.Components)
        {
            if (type.IsInstanceOfType(component)) found.Add((T)(Object)component);
        }
    }
}
