namespace UnityEngine;

public sealed class AddComponentMenu : Attribute
{
    public AddComponentMenu(string menuName) => componentMenu = menuName;

    public string componentMenu { get; }
}
