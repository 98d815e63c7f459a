using System;
using Nowpose.Latency.Load;
using Nowpose.Unity.Calibration;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Loads the GPU with a wall of small triangles with an adjustable number of vertices, to find the end of the constant-latency range.
    /// </summary>
    /// <remarks>
    /// The wall is centred on this object and perpendicular to its z axis. It loads the GPU only while it is in view. The component builds the wall
    /// in small steps within a time budget per frame, so no frame becomes late. It keeps the parts that it has built, so it can return to an earlier
    /// load without delay.
    /// </remarks>
    [AddComponentMenu("Nowpose/Load Generator")]
    [DisallowMultipleComponent]
    public sealed class LoadGenerator : MonoBehaviour
    {
        [SerializeField, Tooltip("Material of the wall. Choose a dark one: a headset's display only adds light, so black is not visible.")]
        Material _material = null;

        [SerializeField, Range(0, LoadMesh.MaxVertices), Tooltip("Number of vertices to draw. A load sweep sets it.")]
        int _vertices = 0;

        [SerializeField, Range(MinMsPerFrame, MaxMsPerFrame), Tooltip("Maximum time per frame to build a load, ms. Default 2: an eighth of a "
            + "frame at 60 Hz, which a scene below its limit can spare.")]
        float _msPerFrame = 2;

        [SerializeField, Range(0.05f, 5), Tooltip("Width of the wall in metres; its height is 0.625 times the width. Default 0.6: the whole wall "
            + "is in view from 1.3 m.")]
        float _widthMetres = 0.6f;

        const float MinMsPerFrame = 0.1f, MaxMsPerFrame = 10;

        LoadPatches _patches;

        /// <summary>
        /// Number of vertices to draw, 0 to 2 000 000. The wall reaches this number after some frames. If the number is one or two above a multiple
        /// of 25 000, these one or two vertices are not drawn, because they form no triangle.
        /// </summary>
        /// <exception cref="InputException">The value is out of range. The load does not change.</exception>
        public int Vertices
        {
            get => _vertices;
            set
            {
                LoadMesh.PatchesOf(value);
                _vertices = value;
            }
        }

        /// <summary>Number of vertices that this frame draws if the wall is in view.</summary>
        public int VerticesShown => _patches?.VerticesShown ?? 0;

        /// <summary>Whether all <see cref="Vertices"/> are drawn.</summary>
        public bool IsReady => _patches != null && VerticesShown == LoadMesh.DrawnOf(_vertices);

        /// <summary>Reason why nothing is drawn, in one line; null if no problem is known.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        void OnEnable()
        {
            Problem = null;
            if (_material == null) Fail(ComponentMessages.NoMaterial);
            else if (_vertices < 0 || _vertices > LoadMesh.MaxVertices)
                Fail(ComponentMessages.Vertices(_vertices, LoadMesh.MaxVertices));
            else _patches = new LoadPatches(
                transform, _material, _widthMetres, this.SessionOr(null).ClockOrDevices(),
                Mathf.Clamp(_msPerFrame, MinMsPerFrame, MaxMsPerFrame));
        }

        void OnDisable()
        {
            _patches?.Destroy();
            _patches = null;
        }

        void Update()
        {
            if (_patches == null) return;
            _patches.Ask(_vertices);
            _patches.Advance();
        }

        void Fail(string what)
        {
            Problem = "load generator '" + name + "' " + what;
            ConsoleLog.Fail(this, Problem);
        }
    }
}
