using Nowpose.UnityPlayer.Assets;
using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Saving;

namespace Nowpose.UnityPlayer;

/// <summary>
/// Writes objects in Unity's text format. The same objects produce the same text on every machine. Writing the objects of a file that
/// <see cref="AssetLibrary"/> has loaded reproduces the text of the file.
/// </summary>
/// <param name="library">Library with the assets and scripts to which the objects refer.</param>
public sealed class AssetWriter(AssetLibrary library)
{
    /// <summary>Writes a prefab.</summary>
    /// <param name="root">Root object of the prefab. Its descendants are included.</param>
    /// <exception cref="AssetException">An object refers to an object that is neither below the root nor an asset of the library.</exception>
    public string Prefab(GameObject root) => UnityDocumentWriter.Write(HierarchyWriter.Write(library.Loaded, new[] { root }, root.name));

    /// <summary>Writes a scene with the settings of a new scene.</summary>
    /// <param name="roots">Root objects of the scene in order.</param>
    /// <exception cref="AssetException">An object refers to an object that is neither below the roots nor an asset of the library.</exception>
    public string Scene(IReadOnlyList<GameObject> roots) => Scene(roots, SceneSettings.Default);

    /// <summary>Writes a ScriptableObject as an asset.</summary>
    /// <exception cref="AssetException">The object refers to an object that is not an asset of the library.</exception>
    public string Asset(ScriptableObject asset) => Alone(asset, ScriptClass.Of(asset.GetType()), ScriptClass.AssetFileId);

    /// <summary>Writes a material as an asset.</summary>
    /// <exception cref="AssetException">The shader of the material is not an asset of the library.</exception>
    public string Asset(Material material) => Alone(material, MaterialClass.Class, MaterialClass.FileId);

    internal string Scene(IReadOnlyList<GameObject> roots, IReadOnlyList<UnityDocument> settings) =>
        UnityDocumentWriter.Write(settings.Concat(HierarchyWriter.Write(library.Loaded, roots, "scene")));

    string Alone(Object target, ObjectClass known, long fileId)
    {
        var own = new Dictionary<long, Object> { [fileId] = target };
        var references = new FileReferences(library.Loaded, own, System.Array.Empty<GameObject>());
        var fields = known.Write(target, references, new Place(target.name + " " + known.Type.Name));
        return UnityDocumentWriter.Write(new[] { new UnityDocument(known.Id, known.Name, fileId, fields) });
    }
}
