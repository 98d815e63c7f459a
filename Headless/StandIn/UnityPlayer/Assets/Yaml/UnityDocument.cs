namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>One object in a file: the header <c>--- !u!CLASS &amp;FILEID</c>, the name of the class, and the fields.</summary>
/// <param name="ClassId">Number of the class.</param>
/// <param name="ClassName">Name of the class.</param>
/// <param name="FileId">FileID of the object. It is unique in the file and is not 0.</param>
/// <param name="Fields">Fields of the object in the order of the file.</param>
/// <param name="IsStripped">
/// Whether the document is a placeholder for an object of a prefab instance. A placeholder only identifies the object.
/// </param>
sealed record UnityDocument(int ClassId, string ClassName, long FileId, YamlMappingNode Fields, bool IsStripped = false)
{
    public override string ToString() => "&" + Numbers.Write(FileId) + " " + ClassName;
}
