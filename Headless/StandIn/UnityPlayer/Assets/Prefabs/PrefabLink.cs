namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Identifies the prefab object that an object instantiates.</summary>
sealed record PrefabLink(PrefabInstance Instance, long SourceFileId);
