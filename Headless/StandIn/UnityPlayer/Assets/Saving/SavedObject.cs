using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Saving;

/// <summary>An object that is written to a file.</summary>
sealed class SavedObject(Object target, long fileId, PrefabLink link)
{
    public Object Target { get; } = target;
    public long FileId { get; } = fileId;

    /// <summary>The prefab object that this object instantiates; null for an object of the file itself.</summary>
    public PrefabLink Link { get; } = link;

    public ObjectClass Class { get; } = EngineClasses.Of(target) ?? ScriptClass.Of(target.GetType());

    public string ClassName => Target is OpaqueComponent opaque ? opaque.ClassName : Class.Name;

    /// <summary>Fields of the object; null before <see cref="Write"/> has been called.</summary>
    public YamlMappingNode Fields { get; private set; }

    public void Write(FileReferences references) => Fields = Class.Write(Target, references, new Place(Target.name + " " + Class.Type.Name));

    public UnityDocument Document() => new UnityDocument(Class.Id, ClassName, FileId, Fields);

    /// <summary>Returns the placeholder for an object of a prefab instance.</summary>
    public UnityDocument Stripped()
    {
        var fields = Nodes.Lines(
            ("m_CorrespondingSourceObject", Source().Write()),
            ("m_PrefabInstance", new AssetReference(Link.Instance.FileId).Write()),
            ("m_PrefabAsset", AssetReference.None.Write()));
        if (Class is ScriptClass)
        {
            fields.Add("m_GameObject", AssetReference.None.Write());
            foreach (var name in new[] { "m_Enabled", "m_EditorHideFlags", ScriptClass.ScriptField, "m_Name", "m_EditorClassIdentifier" })
                fields.Add(name, Nodes.Find(Fields, name));
        }
        return new UnityDocument(Class.Id, ClassName, FileId, fields, IsStripped: true);
    }

    /// <summary>Returns the reference to the prefab object that this object instantiates.</summary>
    public AssetReference Source() => new AssetReference(Link.SourceFileId, Link.Instance.SourceGuid, AssetReference.Imported);
}
