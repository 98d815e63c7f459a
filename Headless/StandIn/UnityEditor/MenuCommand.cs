namespace UnityEditor;

public sealed class MenuCommand(Object inContext, int inUserData)
{
    public Object context = inContext;
    public int userData = inUserData;

    public MenuCommand(Object inContext) : this(inContext, 0) { }
}
