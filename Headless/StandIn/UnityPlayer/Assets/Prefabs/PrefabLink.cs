namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Identifies the prefab object that an object instantiates.</summary>
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
