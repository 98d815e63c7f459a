using Nowpose.UnityPlayer.Assets;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>A temporary project with a prefab whose script has a field of each kind.</summary>
sealed class ProbedProject : IDisposable
{
    public const string Arm = """
        --- !u!1 &1
        GameObject:
          m_Component:
          - component: {fileID: 2}
          - component: {fileID: 3}
          m_Layer: 5
          m_Name: Arm
          m_TagString: Player
          m_IsActive: 1
        --- !u!4 &2
        Transform:
          m_GameObject: {fileID: 1}
          m_LocalRotation: {x: 0, y: 0.6, z: 0, w: 0.8}
          m_LocalPosition: {x: 1, y: -2, z: 0.25}
          m_LocalScale: {x: 2, y: 2, z: 2}
          m_Children:
          - {fileID: 12}
          m_Father: {fileID: 0}
        --- !u!114 &3
        MonoBehaviour:
          m_GameObject: {fileID: 1}
          m_Enabled: 0
          m_Script: {fileID: 11500000, guid: 00000000000000000000000000000001, type: 3}
        PROBE
        --- !u!1 &11
        GameObject:
          m_Component:
          - component: {fileID: 12}
          m_Name: Hand
          m_IsActive: 0
        --- !u!4 &12
        Transform:
          m_GameObject: {fileID: 11}
          m_Children: []
          m_Father: {fileID: 2}

        """;

    public ProbedProject()
    {
        Project = new TemporaryProject().AddScript<LoaderProbe>(1).AddScript<LoaderProbeAsset>(2);
    }

    public TemporaryProject Project { get; }

    public GameObject Load(string probeFields)
    {
        Project.AddYaml("Assets/Arm.prefab", 3, Arm.Replace("PROBE\n", probeFields.Length == 0 ? "" : probeFields + "\n", StringComparison.Ordinal));
        return Project.Library().Load<GameObject>("Assets/Arm.prefab");
    }

    public LoaderProbe Probe(string fields) => Load(fields).GetComponent<LoaderProbe>();

    public static string Scriptable(string name, string fields)
    {
        return "--- !u!114 &11400000\nMonoBehaviour:\n  m_Script: {fileID: 11500000, guid: " + GuidOf(2)
            + ", type: 3}\n  m_Name: " + name + "\n" + fields;
    }

    /// <param name="place">File, id of the object and field, or a part of them.</param>
    /// <param name="detail">The wrong value, name or number in the message.</param>
    public static NUnit.Framework.Constraints.Constraint Refused(object fault, string place, string detail = "")
    {
        return Throws.TypeOf<AssetException>().With.Property(nameof(AssetException.Fault)).EqualTo(fault)
            .And.Message.Contains(place + ": ").And.Message.Contains(detail);
    }

    public void Dispose() => Project.Dispose();
}
