namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of a layer mask, which is an int in Unity's API: <c>serializedVersion: 2, m_Bits: 4294967295</c>.</summary>
sealed class BitsFormat : IValueFormat
{
    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var text = place.In("m_Bits").Scalar(Nodes.Find(place.Mapping(node), "m_Bits"));
        return Numbers.TryRead(text, out long bits) && bits >= 0 && bits <= uint.MaxValue
            ? (object)unchecked((int)bits)
            : throw place.In("m_Bits").Error(AssetFault.Value, "\"" + text + "\" is not a set of 32 layers");
    }

    public YamlNode Write(object value, FileReferences references, Place place) =>
        Nodes.Lines(("serializedVersion", Nodes.Number(2)), ("m_Bits", Nodes.Number(unchecked((uint)(int)value))));
}
