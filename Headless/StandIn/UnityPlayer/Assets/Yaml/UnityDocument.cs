using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>One object of a file: <c>--- !u!CLASS &amp;FILEID</c>, the name of its class and its fields.</summary>
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

    /// <summary>Unique in its file, never 0.</summary>
    public long FileId { get; }

    public YamlMappingNode Fields { get; }

    /// <summary>Whether it is a placeholder for an object of a prefab instance, which identifies the object and has no fields of its own.</summary>
    public bool IsStripped { get; }

    public override string ToString() => "&" + Numbers.Write(FileId) + " " + ClassName;
}
