namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Leading fields that the objects of many classes have in common.</summary>
static class Headers
{
    /// <summary>First fields of an object that does not belong to a prefab instance.</summary>
    public static IEnumerable<Slot> Object { get; } = new[]
    {
        Slot.Constant("m_ObjectHideFlags", Nodes.Number(0)),
        Slot.Constant("m_CorrespondingSourceObject", AssetReference.None.Write()),
        Slot.Constant("m_PrefabInstance", AssetReference.None.Write()),
        Slot.Constant("m_PrefabAsset", AssetReference.None.Write()),
    };

    public static IEnumerable<Slot> Component { get; } = Object.Append(Slot.Checked("m_GameObject", (Component c) => c.gameObject)).ToArray();
}
