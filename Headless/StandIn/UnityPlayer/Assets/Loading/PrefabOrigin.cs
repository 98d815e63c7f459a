using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets.Prefabs;

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

/// <summary>The objects and settings of a scene file. The objects have not received Awake and are not in a scene yet.</summary>
/// <param name="Roots">Root objects of the scene in order.</param>
/// <param name="Settings">Settings of the whole scene.</param>
sealed record LoadedScene(IReadOnlyList<GameObject> Roots, IReadOnlyList<UnityDocument> Settings);
