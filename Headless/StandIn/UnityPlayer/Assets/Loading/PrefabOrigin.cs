using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets.Prefabs;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>
/// Stores the prefab object that an object in a hierarchy instantiates. The object can therefore be saved as part of a prefab instance.
/// </summary>
sealed class PrefabOrigin
{
    static readonly ConditionalWeakTable<Object, PrefabOrigin> Origins = new ConditionalWeakTable<Object, PrefabOrigin>();

    PrefabOrigin(Group group, long sourceFileId)
    {
        Instance = group;
        SourceFileId = sourceFileId;
    }

    /// <summary>The prefab instance to which the object belongs. All objects of an instance share one <see cref="Group"/>.</summary>
    public Group Instance { get; }

    public long SourceFileId { get; }

    /// <summary>Returns the origin of an object; null if the object does not belong to a prefab instance.</summary>
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
