using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class MenuCommand
{
    public Object context;
    public int userData;

    public MenuCommand(Object inContext) : this(inContext, 0) { }

    public MenuCommand(Object inContext, int inUserData)
    {
        context = inContext;
        userData = inUserData;
    }
}
