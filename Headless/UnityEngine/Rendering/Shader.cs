using System.Collections.Generic;

namespace UnityEngine;

public sealed class Shader : Object
{
    // Ids hold for the process, as the engine says: code keeps them in static fields.
    static readonly Dictionary<string, int> Ids = new();

    internal Shader() { }

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
