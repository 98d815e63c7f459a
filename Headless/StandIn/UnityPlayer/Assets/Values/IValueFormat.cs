using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>How the values of one type stand in Unity's files, both ways: what <see cref="Write"/> makes, <see cref="Read"/> takes back.</summary>
interface IValueFormat
{
    /// <param name="node">What the file has.</param>
    /// <param name="current">The value before, from which what the file leaves out is taken; may be null.</param>
    /// <param name="references">Of the file.</param>
    /// <param name="place">For errors.</param>
    object Read(YamlNode node, object current, IReferences references, Place place);

    YamlNode Write(object value, IReferences references, Place place);
}
