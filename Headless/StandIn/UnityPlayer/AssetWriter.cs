using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets;
using Nowpose.UnityPlayer.Assets.Loading;
using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Saving;
using Nowpose.UnityPlayer.Assets.Values;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>
/// Writes objects as Unity's editor would save them. The same objects give the same text, everywhere: what <see cref="AssetLibrary"/>
/// loaded from it is written as it was.
/// </summary>
public sealed class AssetWriter
{
    readonly AssetLibrary _library;

    /// <param name="library">Has the assets and scripts that are referred to.</param>
    public AssetWriter(AssetLibrary library) => _library = library;

    /// <param name="root">With all below it.</param>
    /// <exception cref="AssetException">It refers to what is neither below it nor an asset of the library.</exception>
    public string Prefab(GameObject root)
    {
        return UnityDocumentWriter.Write(HierarchyWriter.Write(_library.Loaded, new[] { root }, root.name));
    }

    /// <summary>A stand-in for somebody else's prefab: its objects have the fileIDs that they have there.</summary>
    /// <param name="root">With all below it.</param>
    /// <param name="fileIds">Of the objects that matter; the others get some.</param>
    internal string Prefab(GameObject root, IReadOnlyDictionary<Object, long> fileIds)
    {
        return UnityDocumentWriter.Write(HierarchyWriter.Write(_library.Loaded, new[] { root }, root.name, fileIds));
    }

    /// <summary>With the settings that a new scene has.</summary>
    /// <param name="roots">In order.</param>
    /// <exception cref="AssetException">They refer to what is neither below them nor an asset of the library.</exception>
    public string Scene(IReadOnlyList<GameObject> roots) => Scene(roots, SceneSettings.Default);

    /// <exception cref="AssetException">It refers to what is not an asset of the library.</exception>
    public string Asset(ScriptableObject asset) => Alone(asset, ScriptClass.Of(asset.GetType()), ScriptClass.AssetFileId);

    /// <exception cref="AssetException">Its shader is not of the library.</exception>
    public string Asset(Material material) => Alone(material, MaterialClass.Class, MaterialClass.FileId);

    internal string Scene(IReadOnlyList<GameObject> roots, IReadOnlyList<UnityDocument> settings)
    {
        return UnityDocumentWriter.Write(settings.Concat(HierarchyWriter.Write(_library.Loaded, roots, "scene")));
    }

    string Alone(Object target, ObjectClass known, long fileId)
    {
        var own = new Dictionary<long, Object> { [fileId] = target };
        var references = new FileReferences(_library.Loaded, own, System.Array.Empty<GameObject>());
        var fields = known.Write(target, references, new Place(target.name + " " + known.Type.Name));
        return UnityDocumentWriter.Write(new[] { new UnityDocument(known.Id, known.Name, fileId, fields) });
    }
}
