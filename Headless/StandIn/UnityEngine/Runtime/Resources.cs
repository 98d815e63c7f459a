namespace UnityEngine;

public sealed class Resources
{
    public static T GetBuiltinResource<T>(string path) where T : Object => (T)GetBuiltinResource(typeof(T), path);

    public static Object GetBuiltinResource(Type type, string path) => BuiltIn.Resource(path);
}
