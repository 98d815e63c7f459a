namespace UnityEngine;

public class Texture : Object
{
    protected Texture() { }
}
