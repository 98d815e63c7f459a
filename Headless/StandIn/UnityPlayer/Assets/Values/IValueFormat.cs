using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>The format of the values of one type in Unity's files. <see cref="Read"/> reads what <see cref="Write"/> writes.</summary>
interface IValueFormat
{
    /// <param name="node">The node in the file.</param>
    /// <param name="current">The previous value, which supplies parts missing in the file; may be null.</param>
    /// <param name="references">References of the file.</param>
    /// <param name="place">Place for errors.</param>
    object Read(YamlNode node, object current, IReferences references, Place place);

    YamlNode Write(object value, IReferences references, Place place);
}
