using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets.Prefabs;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>Stores, for an object in a hierarchy, the prefab object of which it is an instance, so that it can be saved as an instance.</summary>
sealed class PrefabOrigin
{
    static readonly ConditionalWeakTable<Object, PrefabOrigin> Origins = new ConditionalWeakTable<Object, PrefabOrigin>();

    PrefabOrigin(Group group, long sourceFileId)
    {
        Instance = group;
        SourceFileId = sourceFileId;
    }

    /// <summary>The same object for all objects of one instance.</summary>
    public Group Instance { get; }

    public long SourceFileId { get; }

    /// <summary>Gets the origin; null for an object that is not in a prefab instance.</summary>
    public static PrefabOrigin Of(Object target) => Origins.TryGetValue(target, out var origin) ? origin : null;

    public static void Set(Object target, Group instance, long sourceFileId) => Origins.Add(target, new PrefabOrigin(instance, sourceFileId));

    /// <summary>One instance of a prefab.</summary>
    public sealed class Group
    {
        public Group(string sourceGuid, ObjectFile source)
        {
            SourceGuid = sourceGuid;
            Source = source;
        }

        public string SourceGuid { get; }
        public ObjectFile Source { get; }
    }
}
