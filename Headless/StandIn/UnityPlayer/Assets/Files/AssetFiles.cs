using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>Reads and parses the files of a library, each file once.</summary>
sealed class AssetFiles(AssetIndex index)
{
    readonly Dictionary<string, IReadOnlyList<UnityDocument>> _documents = new Dictionary<string, IReadOnlyList<UnityDocument>>();
    readonly Dictionary<string, ObjectFile> _hierarchies = new Dictionary<string, ObjectFile>();
    readonly Dictionary<string, ShaderDeclaration> _shaders = new Dictionary<string, ShaderDeclaration>();

    public AssetIndex Index { get; } = index;

    public ScriptTypes Scripts { get; } = new ScriptTypes(index);

    public IReadOnlyList<UnityDocument> Documents(AssetFile file)
    {
        if (!_documents.TryGetValue(file.Guid, out var documents))
            _documents.Add(file.Guid, documents = UnityDocumentReader.Read(file.ReadText(), file.Path));
        return documents;
    }

    /// <summary>Returns the objects of a prefab or scene, without the settings of the scene.</summary>
    public ObjectFile Hierarchy(AssetFile file)
    {
        if (_hierarchies.TryGetValue(file.Guid, out var known)) return known
            ?? throw new AssetException(AssetFault.Hierarchy, file.Path + ": is an instance of itself");
        _hierarchies.Add(file.Guid, null);
        try
        {
            var read = ObjectFile.Read(Documents(file).Where(d => !SceneSettings.Holds(d)).ToList(), file.Path, PrefabAt);
            return _hierarchies[file.Guid] = read;
        }
        catch (AssetException)
        {
            _hierarchies.Remove(file.Guid);
            throw;
        }
    }

    public ShaderDeclaration Shader(AssetFile file)
    {
        if (!_shaders.TryGetValue(file.Guid, out var declaration))
            _shaders.Add(file.Guid, declaration = ShaderDeclaration.Read(file.ReadText(), file.Path));
        return declaration;
    }

    ObjectFile PrefabAt(string guid)
    {
        var file = Index.ByGuid(guid);
        return file?.Extension == ".prefab" ? Hierarchy(file) : throw new AssetException(AssetFault.MissingAsset, "no prefab has the GUID " + guid);
    }
}
