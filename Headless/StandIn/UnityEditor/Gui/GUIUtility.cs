namespace UnityEngine;

public class GUIUtility
{
}
