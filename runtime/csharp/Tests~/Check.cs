// Holds the binding to the C library: Check FIELD POINTS ANSWERS, the answers as the C example query.c prints them, with
// nine digits, which tell every float from its neighbours.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Nearfield;

internal static class Check
{
    private static int failures;

    private static void Expect(bool holds, string what)
    {
        if (holds) return;
        failures++;
        Console.Error.WriteLine("FAILED: " + what);
    }

    private static void ExpectThrow<E>(Action action, string what) where E : Exception
    {
        try { action(); }
        catch (E) { return; }
        Expect(false, what + " throws no " + typeof(E).Name);
    }

    private static float[][] Numbers(string path) =>
        File.ReadLines(path).Select(line => line.Split(' ').Select(word => Number(word)).ToArray()).ToArray();

    private static float Number(string word)
    {
        if (word == "inf") return float.PositiveInfinity;
        if (word == "-inf") return float.NegativeInfinity;
        return float.Parse(word, CultureInfo.InvariantCulture);
    }

    private static int Bits(float number) => BitConverter.ToInt32(BitConverter.GetBytes(number), 0);

    /// <summary>The line that query.c prints for a point.</summary>
    private static float[] Answers(Field field, Vector point)
    {
        var line = new List<float>();
        Action<Vector> add = v => line.AddRange(new[] { v.X, v.Y, v.Z });
        line.Add(field.Distance(point));
        add(field.DistanceAndGradient(point).Gradient);
        add(field.Normal(point));
        ClosestPoint closest = field.ClosestPoint(point);
        add(closest.Point);
        line.AddRange(new[] { closest.Residual, closest.Steps });
        FieldRange range = field.Range(new Vector(point.X - 0.1f, point.Y - 0.1f, point.Z - 0.1f),
                                  new Vector(point.X + 0.1f, point.Y + 0.1f, point.Z + 0.1f));
        line.AddRange(new[] { field.Clearance(point), range.Min, range.Max });
        FieldRayHit hit = field.Raycast(new FieldRay { Origin = point, Direction = new Vector(1, 2, 3), Length = 1e3f });
        line.AddRange(new[] { (float)hit.End, hit.Steps, hit.Distance });
        add(hit.Point);
        add(hit.Normal);
        return line.ToArray();
    }

    private static void SameAsInC(Field field, Vector[] points, float[][] expected)
    {
        Expect(points.Length == expected.Length && points.Length > 0, "as many answers as points");
        for (int i = 0; i < points.Length; i++)
        {
            float[] ours = Answers(field, points[i]);
            // The last four numbers are a distance and a gradient of an instance, which is not bound.
            Expect(ours.Select(Bits).SequenceEqual(expected[i].Take(expected[i].Length - 4).Select(Bits)),
                   $"at {points[i]} C says {string.Join(" ", expected[i])}, we {string.Join(" ", ours)}");
        }
    }

    private static void BatchesSayTheSame(Field field, Vector[] points)
    {
        var distances = new float[points.Length];
        var again = new float[points.Length];
        var gradients = new Vector[points.Length];
        field.Distances(points, distances);
        field.DistancesAndGradients(points, again, gradients);
        for (int i = 0; i < points.Length; i++)
        {
            Sample sample = field.DistanceAndGradient(points[i]);
            Expect(Bits(sample.Distance) == Bits(distances[i]) && Bits(sample.Distance) == Bits(again[i])
                   && sample.Gradient.Equals(gradients[i]), $"a batch differs at {points[i]}");
            Expect(field.IsClear(points[i], 0.01f) == (field.Clearance(points[i]) > 0.01f), $"clear at {points[i]}");
        }
        ExpectThrow<ArgumentException>(() => field.Distances(points, new float[1]), "a short array");
        ExpectThrow<ArgumentNullException>(() => field.Distances(null, distances), "null");
    }

    private static void InfoIsOfTheFile(Field field, byte[] file)
    {
        Info info = field.Info;
        Expect(info.BoxMin.X < info.BoxMax.X && info.BoxMin.Y < info.BoxMax.Y && info.BoxMin.Z < info.BoxMax.Z, "the box");
        string hexadecimal = BitConverter.ToString(file, 0, Math.Min(file.Length, 512)).Replace("-", "").ToLowerInvariant();
        Expect(info.MeshHash.Length == 32 && hexadecimal.Contains(info.MeshHash), "the hash of the mesh stands in the file");
        Expect(info.SettingsHash.Length == 16 && hexadecimal.Contains(info.SettingsHash), "the hash of the settings too");
    }

    private static void DamageIsNamed(byte[] file)
    {
        for (int length = 0; length < file.Length; length += 1 + file.Length / 50)
            ExpectThrow<FieldException>(() => new Field(file.Take(length).ToArray()), $"{length} bytes of {file.Length}");
        var damaged = (byte[])file.Clone();
        damaged[file.Length - 1] ^= 1;
        try { new Field(damaged); Expect(false, "a damaged byte passes"); }
        catch (FieldException error) { Expect(error.Result > 0 && error.Message.Length > 10, error.Message); }
        ExpectThrow<ArgumentNullException>(() => new Field(null), "null");
    }

    private static int Main(string[] arguments)
    {
        byte[] file = File.ReadAllBytes(arguments[0]);
        Vector[] points = Numbers(arguments[1]).Select(p => new Vector(p[0], p[1], p[2])).ToArray();
        var field = new Field(file);
        SameAsInC(field, points, Numbers(arguments[2]));
        BatchesSayTheSame(field, points);
        InfoIsOfTheFile(field, file);
        DamageIsNamed(file);
        field.Dispose();
        field.Dispose();
        ExpectThrow<ObjectDisposedException>(() => field.Distance(points[0]), "a field that is disposed");
        return failures == 0 ? 0 : 1;
    }
}
