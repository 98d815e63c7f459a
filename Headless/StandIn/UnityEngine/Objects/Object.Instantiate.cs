using UnityEngine.Serialization;

namespace UnityEngine;

public partial class Object
{
    public static T Instantiate<T>(T original) where T : Object => Instantiate(original, null);
    public static T Instantiate<T>(T original, Transform parent) where T : Object => Instantiate(original, parent, false);

    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object =>
        (T)Cloner.Instantiate(original, parent, worldPositionStays);
}
