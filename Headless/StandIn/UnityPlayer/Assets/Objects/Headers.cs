using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>The first fields of objects of many classes.</summary>
static class Headers
{
    /// <summary>An object of the file's own, not of a prefab instance.</summary>
    public static IEnumerable<Slot> Object { get; } = new[]
    {
        Slot.Constant("m_ObjectHideFlags", Nodes.Number(0)),
        Slot.Constant("m_CorrespondingSourceObject", AssetReference.None.Write()),
        Slot.Constant("m_PrefabInstance", AssetReference.None.Write()),
        Slot.Constant("m_PrefabAsset", AssetReference.None.Write()),
    };

    public static IEnumerable<Slot> Component { get; } = Object.Append(Slot.Checked("m_GameObject", (Component c) => c.gameObject)).ToArray();
}
