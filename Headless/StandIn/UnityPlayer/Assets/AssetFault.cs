namespace Nowpose.UnityPlayer.Assets;

/// <summary>The kinds of errors in an asset file.</summary>
public enum AssetFault
{
    /// <summary>The file has another form than an asset of its kind.</summary>
    Document,

    /// <summary>The header of the file or of an object is missing or wrong.</summary>
    Header,

    /// <summary>The file contains no object.</summary>
    NoObject,

    /// <summary>The id of an object is not a 64-bit integer other than 0.</summary>
    FileId,

    /// <summary>An object does not contain exactly one class with its fields.</summary>
    ClassCount,

    /// <summary>An object is not valid YAML.</summary>
    Syntax,

    /// <summary>The object has no field of this name, or lacks a necessary field.</summary>
    UnknownField,

    /// <summary>The field needs another kind of value: a single value, named values, a list or a reference.</summary>
    Kind,

    /// <summary>The value cannot be read as the type of the field.</summary>
    Value,

    /// <summary>An index is beyond the end of its list.</summary>
    OutOfRange,

    /// <summary>An id, a GUID or a list entry occurs twice.</summary>
    Duplicate,

    /// <summary>A file does not contain the object of a reference.</summary>
    MissingObject,

    /// <summary>No asset has the GUID or the path.</summary>
    MissingAsset,

    /// <summary>A reference leads to an object that the field cannot hold.</summary>
    Reference,

    /// <summary>Objects, components, parents and children contradict each other.</summary>
    Hierarchy,

    /// <summary>A script does not contain the necessary class.</summary>
    Script,

    /// <summary>An instance was written with another version of its prefab.</summary>
    Outdated,

    /// <summary>The stand-in does not support the class, field or value.</summary>
    Unsupported,
}
