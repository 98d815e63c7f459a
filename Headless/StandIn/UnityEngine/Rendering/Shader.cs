using System.Globalization;

namespace UnityEngine;

public sealed class Shader : Object
{
    static readonly Dictionary<string, int> Queues = new()
    {
        ["Background"] = 1000, ["Geometry"] = 2000, ["AlphaTest"] = 2450, ["Transparent"] = 3000, ["Overlay"] = 4000,
    };

    // As in Unity, the ids are valid for the whole process: code stores them in static fields.
    static readonly Dictionary<string, int> Ids = new();

    internal Shader() { }

    /// <summary>Tags of the SubShader in use.</summary>
    internal IReadOnlyDictionary<string, string> Tags { get; set; } = new Dictionary<string, string>();

    public int renderQueue
    {
        get
        {
            if (!Tags.TryGetValue("Queue", out var queue)) return 2000;

            var offset = queue.AsSpan().IndexOfAny('+', '-');
            var named = Queues[offset < 0 ? queue : queue.Substring(0, offset)];
            return offset < 0 ? named : named + int.Parse(queue.Substring(offset), CultureInfo.InvariantCulture);
        }
    }

    public static int PropertyToID(string name)
    {
        lock (Ids)
        {
            if (!Ids.TryGetValue(name, out var id)) Ids.Add(name, id = Ids.Count + 1);
            return id;
        }
    }

    public static Shader Find(string name) => World.Current.Shaders.TryGetValue(name, out var shader) ? shader : null;
}
