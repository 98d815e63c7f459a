namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of a value that is one scalar.</summary>
sealed class ScalarFormat<T>(ScalarFormat<T>.Parser parse, Func<T, string> format) : IValueFormat
{
    public delegate bool Parser(string text, out T value);

    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var text = place.Scalar(node);
        return parse(text, out var value) ? value : throw place.Error(AssetFault.Value, "\"" + text + "\" is not a valid " + typeof(T).Name);
    }

    public YamlNode Write(object value, FileReferences references, Place place) => Nodes.Text(format((T)value));
}
