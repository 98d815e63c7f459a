namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of a Color32: one number that contains the four bytes. Red is the lowest byte.</summary>
sealed class ColourFormat : IValueFormat
{
    const string Version = "serializedVersion";
    const string Number = "rgba";

    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var mapping = place.Mapping(node);
        if (mapping.Children.Count != 2 || Nodes.Find(mapping, Version) == null || Nodes.Find(mapping, Number) == null)
            throw place.Error(AssetFault.Kind, "has to be serializedVersion and rgba");
        var text = place.In(Number).Scalar(Nodes.Find(mapping, Number));
        if (!Numbers.TryRead(text, out long bits) || bits < 0 || bits > uint.MaxValue)
            throw place.In(Number).Error(AssetFault.Value, "\"" + text + "\" is not a colour");
        return new Color32((byte)bits, (byte)(bits >> 8), (byte)(bits >> 16), (byte)(bits >> 24));
    }

    public YamlNode Write(object value, FileReferences references, Place place)
    {
        var colour = (Color32)value;
        var bits = colour.r | ((long)colour.g << 8) | ((long)colour.b << 16) | ((long)colour.a << 24);
        return Nodes.Lines((Version, Nodes.Number(2)), (Number, Nodes.Number(bits)));
    }
}
