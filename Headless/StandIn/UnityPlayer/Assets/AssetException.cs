namespace Nowpose.UnityPlayer.Assets;

/// <summary>
/// Thrown when an asset file is invalid, or when Unity would lose some of its data. The message names the file, the fileID of the object, and the
/// field.
/// </summary>
public sealed class AssetException(AssetFault fault, string message, Exception innerException = null) : Exception(message, innerException)
{
    /// <summary>The kind of error.</summary>
    public AssetFault Fault { get; } = fault;
}
