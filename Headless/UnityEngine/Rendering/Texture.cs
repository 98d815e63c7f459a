namespace UnityEngine;

public class Texture : Object
{
    protected Texture() { }

    public virtual int width { get; set; }
    public virtual int height { get; set; }
}
