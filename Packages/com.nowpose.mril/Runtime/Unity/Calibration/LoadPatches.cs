using System;
using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Latency.Load;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Builds the patches of a rendering load in small steps, within a time budget per frame. Patches that a load does not need are hidden and kept
    /// for later loads.
    /// </summary>
    sealed class LoadPatches
    {
        /// <summary>Number of vertices computed in one step: 1/25 of a patch.</summary>
        const int VerticesPerStep = LoadMesh.PatchVertices / 25;

        static readonly int StepKinds = Enum.GetValues(typeof(LoadStep)).Length;

        readonly Transform _parent;
        readonly Material _material;
        readonly float _width;
        readonly IHeadsetClock _clock;
        readonly FrameShare _share;
        readonly List<LoadSlot> _slots = new List<LoadSlot>();
        readonly Vector3[] _vertices = new Vector3[LoadMesh.PatchVertices];
        readonly Vector3[] _normals = new Vector3[LoadMesh.PatchVertices];
        readonly int[] _indices = new int[LoadMesh.PatchOf(0, LoadMesh.PatchVertices).Indices];
        LoadPatch _patch;
        LoadStep _next;
        int _asked, _building, _filled;

        /// <param name="width">Width of the wall that all patches form, in units of the parent.</param>
        /// <param name="clock">Clock that measures the duration of the steps.</param>
        /// <param name="msPerFrame">Time budget per frame in ms; see <see cref="FrameShare"/>.</param>
        public LoadPatches(Transform parent, Material material, float width, IHeadsetClock clock, double msPerFrame)
        {
            _clock = clock;
            _share = new FrameShare(msPerFrame, StepKinds);
            _parent = parent;
            _material = material;
            _width = width;
            for (var i = 0; i < _normals.Length; i++) _normals[i] = Vector3.back;
        }

        /// <summary>Whether all requested vertices are shown.</summary>
        public bool IsComplete { get; private set; } = true;

        /// <summary>Number of vertices of all visible patches.</summary>
        public int VerticesShown { get; private set; }

        /// <summary>Requests a load, given as a number of vertices. Immediately hides the patches that the load does not need.</summary>
        public void Ask(int vertices)
        {
            if (vertices == _asked) return;
            _asked = vertices;
            _filled = 0;
            _next = LoadStep.Compute;
            for (var i = 0; i < _slots.Count; i++) _slots[i].IsShown = Wanted(i) > 0 && _slots[i].Vertices == Wanted(i);
            Count();
        }

        /// <summary>Continues to build the requested load, within the time budget of the frame. Call once per frame.</summary>
        public void Advance()
        {
            if (IsComplete) return;
            var now = _clock.Now;
            _share.BeginFrame(now);
            while (!IsComplete && _share.HasRoom((int)_next, now))
            {
                var step = _next;
                _next = Do(step);
                var then = _clock.Now;
                _share.Took((int)step, then - now);
                now = then;
            }
        }

        public void Destroy()
        {
            foreach (var slot in _slots) slot.Destroy();
            _slots.Clear();
        }

        int Wanted(int slot) => slot < LoadMesh.PatchesOf(_asked) ? LoadMesh.PatchOf(slot, _asked).Vertices : 0;

        // Executes one step and returns the next step.
        LoadStep Do(LoadStep step)
        {
            switch (step)
            {
                case LoadStep.Compute:
                    if (_filled == 0) Begin();
                    Fill(Math.Min(_patch.Vertices, _filled + VerticesPerStep));
                    return _filled < _patch.Vertices ? LoadStep.Compute : LoadStep.SetVertices;
                case LoadStep.SetVertices:
                    _slots[_building].SetVertices(_vertices, _normals, _patch.Vertices);
                    return LoadStep.SetTriangles;
                case LoadStep.SetTriangles:
                    _slots[_building].SetTriangles(_indices, _patch.Indices);
                    return LoadStep.Show;
                default:
                    _slots[_building].Show();
                    _filled = 0;
                    Count();
                    return LoadStep.Compute;
            }
        }

        void Begin()
        {
            _building = 0;
            while (_building < _slots.Count && _slots[_building].Vertices == Wanted(_building)) _building++;
            if (_building == _slots.Count) _slots.Add(new LoadSlot(_parent, _material));
            _patch = LoadMesh.PatchOf(_building, _asked);
        }

        void Fill(int end)
        {
            for (; _filled < end; _filled++)
            {
                _patch.PlaceOf(_filled, out var x, out var y);
                _vertices[_filled] = new Vector3(x * _width, y * _width, 0);
                _patch.WriteTriangles(_filled, _indices);
            }
        }

        void Count()
        {
            VerticesShown = 0;
            foreach (var slot in _slots)
                if (slot.IsShown) VerticesShown += slot.Vertices;
            IsComplete = VerticesShown == LoadMesh.DrawnOf(_asked);
        }
    }
}
