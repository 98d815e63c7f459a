using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>One object in a file: the header <c>--- !u!CLASS &amp;FILEID</c>, the name of the class, and the fields.</summary>
sealed class UnityDocument
{
    public UnityDocument(int classId, string className, long fileId, YamlMappingNode fields, bool isStripped = false)
    {
        ClassId = classId;
        ClassName = className;
        FileId = fileId;
        Fields = fields;
        IsStripped = isStripped;
    }

    public int ClassId { get; }
    public string ClassName { get; }

    /// <summary>FileID of the object. It is unique in the file and is not 0.</summary>
    public long FileId { get; }

    public YamlMappingNode Fields { get; }

    /// <summary>Whether the document is a placeholder for an object of a prefab instance. A placeholder only identifies the object.</summary>
    public bool IsStripped { get; }

    public override string ToString() => "&" + Numbers.Write(FileId) + " " + ClassName;
}
