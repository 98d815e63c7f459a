namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>One object of a file after the prefab instances were replaced with their objects. It has its own copy of the fields.</summary>
sealed class FileObject(int classId, string className, long fileId, YamlMappingNode fields, string file, PrefabLink link)
{
    public FileObject(UnityDocument document, string file)
        : this(document.ClassId, document.ClassName, document.FileId, (YamlMappingNode)LocalReferences.Copy(document.Fields), file, null) { }

    public string File { get; } = file;

    public int ClassId { get; } = classId;
    public string ClassName { get; } = className;

    /// <summary>Whether the object is a Transform or a RectTransform.</summary>
    public bool IsTransform => ClassName is "Transform" or "RectTransform";

    public long FileId { get; } = fileId;
    public YamlMappingNode Fields { get; } = fields;

    /// <summary>The prefab object that this object instantiates; null for an object of the file itself.</summary>
    public PrefabLink Link { get; } = link;

    public Place Place => PlaceAs(ClassName);

    /// <summary>Returns a copy of this prefab object that belongs to an instance of the prefab.</summary>
    public FileObject In(PrefabInstance instance)
    {
        var fields = (YamlMappingNode)LocalReferences.Map(Fields, instance.Map);
        return new FileObject(ClassId, ClassName, instance.Map(FileId), fields, instance.File, new PrefabLink(instance, FileId));
    }

    /// <summary>Returns the place of the object for error messages.</summary>
    /// <param name="name">Name of the object in error messages; for a script, the name of its class.</param>
    public Place PlaceAs(string name) => new Place(File + " &" + Numbers.Write(FileId) + " " + name);

    public AssetReference Reference(string field)
    {
        var node = Nodes.Find(Fields, field) ?? throw Place.Error(AssetFault.UnknownField, "has no " + field);
        return AssetReference.TryRead(node, out var reference) ? reference : throw Place.In(field).Error(AssetFault.Kind, "has to be a reference");
    }
}
