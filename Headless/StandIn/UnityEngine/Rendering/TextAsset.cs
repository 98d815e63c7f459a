namespace UnityEngine;

public class TextAsset : Object
{
    public TextAsset() : this("") { }

    public TextAsset(string text) => this.text = text;

    public string text { get; }

    public override string ToString() => text;
}
