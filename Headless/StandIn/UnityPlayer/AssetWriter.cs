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
/// Writes objects in the editor's format. The same objects give the same text on every machine. Files loaded by <see cref="AssetLibrary"/>
/// are written unchanged.
/// </summary>
public sealed class AssetWriter
{
    readonly AssetLibrary _library;

    /// <param name="library">The library with the referenced assets and scripts.</param>
    public AssetWriter(AssetLibrary library) => _library = library;

    /// <param name="root">The root object; its descendants are included.</param>
    /// <exception cref="AssetException">An object refers to another one that is neither below the root nor an asset of the library.</exception>
    public string Prefab(GameObject root)
    {
        return UnityDocumentWriter.Write(HierarchyWriter.Write(_library.Loaded, new[] { root }, root.name));
    }

    /// <summary>Writes a stand-in for another party's prefab, with the fileIDs of that prefab.</summary>
    /// <param name="root">The root object; its descendants are included.</param>
    /// <param name="fileIds">FileIDs of the relevant objects; the others get generated ones.</param>
    internal string Prefab(GameObject root, IReadOnlyDictionary<Object, long> fileIds)
    {
        return UnityDocumentWriter.Write(HierarchyWriter.Write(_library.Loaded, new[] { root }, root.name, fileIds));
    }

    /// <summary>Writes a scene with the settings of a new scene.</summary>
    /// <param name="roots">The root objects in order.</param>
    /// <exception cref="AssetException">An object refers to another one that is neither below the roots nor an asset of the library.</exception>
    public string Scene(IReadOnlyList<GameObject> roots) => Scene(roots, SceneSettings.Default);

    /// <exception cref="AssetException">The object refers to another one that is not an asset of the library.</exception>
    public string Asset(ScriptableObject asset) => Alone(asset, ScriptClass.Of(asset.GetType()), ScriptClass.AssetFileId);

    /// <exception cref="AssetException">Its shader is not an asset of the library.</exception>
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
