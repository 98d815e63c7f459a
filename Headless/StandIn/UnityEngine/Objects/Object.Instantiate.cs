using UnityEngine.Serialization;

namespace UnityEngine;

public partial class Object
{
    public static Object Instantiate(Object original) => Cloner.Instantiate(original, null, false);
    public static Object Instantiate(Object original, Transform parent) => Instantiate(original, parent, false);

    public static Object Instantiate(Object original, Transform parent, bool instantiateInWorldSpace) =>
        Cloner.Instantiate(original, parent, instantiateInWorldSpace);

    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation) => Instantiate(original, position, rotation, null);

    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation, Transform parent) =>
        Cloner.Instantiate(original, parent, position, rotation);

    public static T Instantiate<T>(T original) where T : Object => (T)Instantiate((Object)original);
    public static T Instantiate<T>(T original, Transform parent) where T : Object => (T)Instantiate((Object)original, parent);

    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object =>
        (T)Instantiate((Object)original, parent, worldPositionStays);

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Object =>
        (T)Instantiate((Object)original, position, rotation);

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent) where T : Object =>
        (T)Instantiate((Object)original, position, rotation, parent);
}
