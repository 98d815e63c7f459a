using System.Globalization;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of an enum: the number of a member. Other numbers are invalid, except sums of members if the enum has [Flags].</summary>
sealed class EnumFormat(Type type) : IValueFormat
{
    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var text = place.Scalar(node);
        if (!Numbers.TryRead(text, out long number)) throw place.Error(AssetFault.Value, "\"" + text + "\" is not a number of a " + type.Name);
        var value = Enum.ToObject(type, number);
        // If the value is not a member or a sum of members, ToString returns the number.
        if (Numbers.TryRead(value.ToString(), out long _)) throw place.Error(AssetFault.Value, text + " is not a member of " + type.Name);
        return value;
    }

    public YamlNode Write(object value, FileReferences references, Place place) => Nodes.Number(Convert.ToInt64(value, CultureInfo.InvariantCulture));
}
