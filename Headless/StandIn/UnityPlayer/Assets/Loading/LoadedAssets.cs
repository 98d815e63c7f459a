using Nowpose.UnityPlayer.Assets.Files;
using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>Loads the assets of a library as objects of one world. Loads each asset when it is first referenced.</summary>
sealed class LoadedAssets(AssetFiles files)
{
    const long ScriptFileId = 11500000;
    const long ShaderFileId = 4800000;
    const long TextFileId = 4900000;

    readonly Dictionary<string, IReadOnlyDictionary<long, Object>> _byGuid = new Dictionary<string, IReadOnlyDictionary<long, Object>>();
    readonly Dictionary<Object, AssetReference> _references = new Dictionary<Object, AssetReference>();

    /// <summary>Returns the main object of an asset. The main object of a prefab is its root.</summary>
    public Object Main(AssetFile file)
    {
        var objects = Load(file);
        return file.Extension == ".prefab" ? objects.Values.OfType<GameObject>().First(g => g.transform.parent == null) : objects.Values.Single();
    }

    public Object ObjectAt(AssetReference reference, Place place)
    {
        if (BuiltInAssets.Holds(reference))
            return BuiltInAssets.Find(reference)
                ?? throw place.Error(AssetFault.MissingObject, "the stand-in has no built-in object with " + reference);
        var file = files.Index.ByGuid(reference.Guid) ?? throw place.Error(AssetFault.MissingAsset, "no asset has the GUID " + reference.Guid);
        var type = TypeOf(file)
            ?? throw place.Error(AssetFault.Reference, "refers to an object in " + file.Path + ", whose fileIDs only Unity can resolve");
        if (reference.Type != type) throw place.Error(AssetFault.Reference, "a reference to " + file.Path + " has type: " + Numbers.Write(type));
        var objects = Load(file, place);
        var fileId = file.Extension == ".prefab" ? files.Hierarchy(file).Find(reference.FileId)?.FileId ?? 0 : reference.FileId;
        return objects.TryGetValue(fileId, out var found)
            ? found
            : throw place.Error(AssetFault.MissingObject, file.Path + " has no object " + Numbers.Write(reference.FileId));
    }

    public AssetReference ReferenceTo(Object target, Place place) =>
        BuiltInAssets.TryFind(target, out var reference) || _references.TryGetValue(target, out reference)
            ? reference
            : throw place.Error(AssetFault.Reference, "refers to " + target + ", which is neither in this file nor an asset");

    /// <summary>Returns the class of a component or ScriptableObject.</summary>
    public Type ScriptAt(FileObject described, Type baseType)
    {
        var reference = described.Reference(ScriptClass.ScriptField);
        var place = described.Place.In(ScriptClass.ScriptField);
        if (reference.FileId != ScriptFileId || reference.Guid == null || reference.Type != AssetReference.Imported)
            throw place.Error(AssetFault.Kind, "has to be {fileID: 11500000, guid: …, type: 3}");
        var script = files.Index.ByGuid(reference.Guid);
        if (script?.Extension != ".cs") throw place.Error(AssetFault.MissingAsset, "no script has the GUID " + reference.Guid);
        return files.Scripts.Of(script, baseType, place);
    }

    public AssetReference ScriptOf(Type type, Place place)
    {
        var file = files.Scripts.FileOf(type, place);
        return new AssetReference(ScriptFileId, file.Guid, AssetReference.Imported);
    }

    /// <summary>Creates the objects of a scene. Each call creates new objects.</summary>
    public HierarchyBuilder Instantiate(AssetFile file) => HierarchyBuilder.Build(this, files.Hierarchy(file));

    /// <summary>Creates an instance of a prefab. It can be saved as a prefab instance.</summary>
    public GameObject InstantiatePrefab(GameObject prefab)
    {
        if (!_references.TryGetValue(prefab, out var reference) || files.Index.ByGuid(reference.Guid) is not { Extension: ".prefab" } file)
            throw new AssetException(AssetFault.MissingAsset, prefab + " is not a prefab of this library");
        var source = files.Hierarchy(file);
        return HierarchyBuilder.Build(this, source, new PrefabInstance(null, 0, file.Guid, source)).Roots[0];
    }

    IReadOnlyDictionary<long, Object> Load(AssetFile file, Place place)
    {
        try
        {
            return Load(file);
        }
        catch (AssetException exception) when (!exception.Message.StartsWith(file.Path, StringComparison.Ordinal))
        {
            throw new AssetException(exception.Fault, place + ": " + exception.Message, exception);
        }
    }

    IReadOnlyDictionary<long, Object> Load(AssetFile file)
    {
        if (_byGuid.TryGetValue(file.Guid, out var objects)) return objects;
        try
        {
            LoadNew(file);
        }
        catch (AssetException)
        {
            // Removes the objects of an invalid file, so that later calls do not find them.
            _byGuid.Remove(file.Guid);
            throw;
        }
        return _byGuid[file.Guid];
    }

    void LoadNew(AssetFile file)
    {
        switch (file.Extension)
        {
            case ".prefab":
                HierarchyBuilder.Build(this, files.Hierarchy(file), made: b => Add(file, b.Objects));
                break;
            case ".asset":
                LoadAlone(file, ScriptClass.AssetFileId, NewScriptable, made => ((ScriptableObject)made).Wake());
                break;
            case ".mat":
                LoadAlone(file, MaterialClass.FileId, _ => (MaterialClass.Class, new Material((Shader)null)), _ => { });
                break;
            case ".shader":
                var shader = MaterialClass.NewShader(files.Shader(file));
                World.Current.Shaders[shader.name] = shader;
                Add(file, ShaderFileId, shader);
                break;
            default:
                Add(file, TextFileId, new TextAsset(file.ReadText()) { name = file.Name });
                break;
        }
    }

    /// <summary>Loads a file that contains one object.</summary>
    void LoadAlone(AssetFile file, long fileId, Func<FileObject, (ObjectClass Class, Object Made)> make, Action<Object> wake)
    {
        var documents = files.Documents(file);
        if (documents.Count != 1 || documents[0].FileId != fileId)
            throw new AssetException(AssetFault.Document, file.Path + ": must contain one object, &" + Numbers.Write(fileId));
        var described = new FileObject(documents[0], file.Path);
        var (known, made) = make(described);
        if (described.ClassId != known.Id || described.ClassName != known.Name)
            throw described.Place.Error(AssetFault.Kind, "has to be a " + known.Name);
        Add(file, fileId, made);
        var references = new FileReferences(this, _byGuid[file.Guid], Array.Empty<GameObject>());
        known.Read(described.Fields, made, references, described.PlaceAs(known.Type.Name));
        if (made.name != file.Name) throw described.Place.In("m_Name").Error(AssetFault.Value, "\"" + made.name + "\" is not the name of its file");
        wake(made);
    }

    (ObjectClass Class, Object Made) NewScriptable(FileObject described)
    {
        var type = ScriptAt(described, typeof(ScriptableObject));
        return (ScriptClass.Of(type), ScriptableObject.CreateAsleep(type));
    }

    void Add(AssetFile file, long fileId, Object made) => Add(file, new Dictionary<long, Object> { [fileId] = made });

    void Add(AssetFile file, IReadOnlyDictionary<long, Object> objects)
    {
        _byGuid.Add(file.Guid, objects);
        foreach (var (id, made) in objects)
        {
            made.BecomeAsset();
            _references.Add(made, new AssetReference(id, file.Guid, TypeOf(file).Value));
        }
    }

    /// <summary>
    /// Returns the type number that references to an asset contain; null if only Unity can compute the fileIDs of the asset's objects.
    /// </summary>
    static int? TypeOf(AssetFile file) => file.Extension switch
    {
        ".asset" or ".mat" => AssetReference.Native,
        ".prefab" or ".shader" => AssetReference.Imported,
        _ => file.Importer == "TextScriptImporter" ? AssetReference.Imported : (int?)null,
    };
}
