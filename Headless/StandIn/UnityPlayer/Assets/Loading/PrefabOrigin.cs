using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets.Prefabs;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>
/// Stores the prefab object that an object in a hierarchy instantiates. The object can therefore be saved as part of a prefab instance.
/// </summary>
static class PrefabOrigin
{
    static readonly ConditionalWeakTable<Object, PrefabLink> Links = new ConditionalWeakTable<Object, PrefabLink>();

    /// <summary>Returns the origin of an object; null if the object does not belong to a prefab instance.</summary>
    public static PrefabLink Of(Object target) => Links.TryGetValue(target, out var link) ? link : null;

    public static void Set(Object target, PrefabLink link) => Links.Add(target, link);
}
