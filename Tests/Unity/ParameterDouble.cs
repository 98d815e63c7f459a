using System.Globalization;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Has the methods of Unity's Animator that set a parameter by its name, and lists their calls.</summary>
sealed class ParameterDouble : MonoBehaviour
{
    public List<string> Calls { get; } = [];

    public void SetBool(string name, bool value) => Note(name, value);

    public void SetFloat(string name, float value) => Note(name, value);

    public void SetInteger(string name, int value) => Note(name, value);

    void Note(string name, IConvertible value) => Calls.Add(name + " " + value.ToString(CultureInfo.InvariantCulture));
}
