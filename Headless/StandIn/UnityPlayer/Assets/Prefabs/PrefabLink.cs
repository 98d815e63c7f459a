namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Which object of which prefab an object is an instance of.</summary>
sealed class PrefabLink
{
    public PrefabLink(PrefabInstance instance, long sourceFileId)
    {
        Instance = instance;
        SourceFileId = sourceFileId;
    }

    public PrefabInstance Instance { get; }
    public long SourceFileId { get; }
}
