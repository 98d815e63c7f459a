namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of the values of one type in Unity's files. <see cref="Read"/> is the inverse of <see cref="Write"/>.</summary>
interface IValueFormat
{
    /// <summary>Reads a value.</summary>
    /// <param name="node">Node in the file.</param>
    /// <param name="current">Current value of the field; may be null. The result keeps those parts of it that the file does not contain.</param>
    /// <param name="references">References of the file.</param>
    /// <param name="place">Location of the node, for error messages.</param>
    object Read(YamlNode node, object current, FileReferences references, Place place);

    YamlNode Write(object value, FileReferences references, Place place);
}
